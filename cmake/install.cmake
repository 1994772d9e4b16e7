# Installing: the libraries with their headers, the program, and what find_package(planescope) needs.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/planescope)

install(TARGETS planescope_core EXPORT planescope-core ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT planescope-core NAMESPACE planescope:: DESTINATION ${package_dir})
install(DIRECTORY include/planescope DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

# A set of its own, because it needs VTK, which users of planescope::core need not have.
if(PLANESCOPE_RENDER)
  install(TARGETS planescope_render planescope_offscreen EXPORT planescope-render
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          OBJECTS DESTINATION ${CMAKE_INSTALL_LIBDIR}/planescope)
  install(EXPORT planescope-render NAMESPACE planescope:: DESTINATION ${package_dir})
  install(FILES cmake/planescope-offscreen.cmake DESTINATION ${package_dir})
  install(DIRECTORY render/include/planescope DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})  # the VTK filter
  if(TARGET planescope_odometry)  # planescope looks for it beside itself
    install(TARGETS planescope_odometry RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
  install(TARGETS planescope RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})

  # The static library leaves VTK to the programs that link it: the package asks for the same modules.
  get_target_property(PLANESCOPE_VTK_COMPONENTS planescope_render LINK_LIBRARIES)
  list(FILTER PLANESCOPE_VTK_COMPONENTS INCLUDE REGEX "^VTK::")
  list(TRANSFORM PLANESCOPE_VTK_COMPONENTS REPLACE "^VTK::" "")
  list(JOIN PLANESCOPE_VTK_COMPONENTS " " PLANESCOPE_VTK_COMPONENTS)
endif()

configure_package_config_file(cmake/planescopeConfig.cmake.in ${PROJECT_BINARY_DIR}/planescopeConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/planescopeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/planescopeConfig.cmake ${PROJECT_BINARY_DIR}/planescopeConfigVersion.cmake
        DESTINATION ${package_dir})
install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
