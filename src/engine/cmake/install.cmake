# The engine for programs of others: libraries, public headers, a CMake package and a .pc file.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(root ${PROJECT_SOURCE_DIR}/src)
target_sources(runout_core PUBLIC FILE_SET HEADERS BASE_DIRS ${root} FILES
  ${root}/core/geometry.h ${root}/core/vec2.h)
target_sources(runout_engine PUBLIC FILE_SET HEADERS BASE_DIRS ${root} FILES
  ${root}/engine/problem.h ${root}/engine/simulation.h ${root}/engine/state_view.h ${root}/engine/status.h
  ${root}/engine/effects/barrier_force.h ${root}/engine/effects.h
  ${root}/engine/particles/bed_line.h ${root}/engine/particles/discretisation.h
  ${root}/engine/particles/kernel.h ${root}/engine/mass.h
  ${root}/engine/pairs/packing.h ${root}/engine/watch/invariant_readings.h ${root}/engine/watch/phase_clock.h
  ${root}/engine/watch/work_ledger.h)
set_target_properties(runout_core PROPERTIES EXPORT_NAME core)
set_target_properties(runout_engine PROPERTIES EXPORT_NAME engine)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Runout)
install(TARGETS runout_core runout_engine EXPORT RunoutTargets
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/runout
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${CMAKE_INSTALL_INCLUDEDIR}/runout)
install(EXPORT RunoutTargets NAMESPACE Runout:: DESTINATION ${package})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/RunoutConfig.cmake.in RunoutConfig.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(RunoutConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/RunoutConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/RunoutConfigVersion.cmake
              ${CMAKE_CURRENT_LIST_DIR}/FindCHOLMOD.cmake DESTINATION ${package})
configure_file(${CMAKE_CURRENT_LIST_DIR}/runout.pc.in runout.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/runout.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
