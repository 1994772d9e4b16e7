# planescope_enable_offscreen(<target>): makes an executable able to render without a display. Links planescope::render and,
# where VTK has no offscreen window of its own (Debian 12's 9.1), the bridge planescope::offscreen to OSMesa: OSMesa comes before
# every other library, and is kept, so that gl* binds to it; ENABLE_EXPORTS lets GLEW find the bridge's glX symbols in the program.
function(planescope_enable_offscreen target)
  target_link_libraries(${target} PRIVATE planescope::offscreen planescope::render)
  get_target_property(kind planescope::offscreen TYPE)
  if(kind STREQUAL "OBJECT_LIBRARY")
    find_library(PLANESCOPE_OSMESA_LIBRARY NAMES OSMesa REQUIRED)
    mark_as_advanced(PLANESCOPE_OSMESA_LIBRARY)
    set_target_properties(${target} PROPERTIES ENABLE_EXPORTS ON)
    target_link_options(${target} BEFORE PRIVATE
                        "LINKER:--push-state,--no-as-needed,${PLANESCOPE_OSMESA_LIBRARY},--pop-state")
  endif()
endfunction()
