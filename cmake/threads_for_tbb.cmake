# TBB::tbb on std::thread, for the thread sanitizer: see tests/tsan/threads_for_tbb.hpp.
find_package(Threads REQUIRED)
set(stand_in ${PROJECT_BINARY_DIR}/threads_for_tbb)
foreach(header blocked_range enumerable_thread_specific global_control parallel_for parallel_invoke parallel_pipeline
        parallel_reduce parallel_sort task_arena)
  foreach(folder tbb oneapi/tbb)
    file(CONFIGURE OUTPUT ${stand_in}/${folder}/${header}.h
         CONTENT "#include \"${PROJECT_SOURCE_DIR}/tests/tsan/threads_for_tbb.hpp\"\n")
  endforeach()
endforeach()
add_library(TBB::tbb INTERFACE IMPORTED GLOBAL)
target_include_directories(TBB::tbb BEFORE INTERFACE ${stand_in})
target_link_libraries(TBB::tbb INTERFACE Threads::Threads)
