# What `cmake --install` puts where:
#   bin/reprise                             the command line, where it is built
#   lib/                                    the runtime as static libraries
#   include/reprise/runtime/...             its public headers, included as "runtime/playback/player.h"
#   lib/cmake/Reprise/                      find_package(Reprise): Reprise::package, Reprise::playback, reprise_optimize_shader()
#   lib/pkgconfig/reprise.pc, share/        for Makefiles; the man page and shell completion
include(CMakePackageConfigHelpers)

set(REPRISE_INSTALL_INCLUDE ${CMAKE_INSTALL_INCLUDEDIR}/reprise)
set(REPRISE_INSTALL_CMAKE ${CMAKE_INSTALL_LIBDIR}/cmake/Reprise)

# The runtime's libraries under the names that users link: reprise_playback is Reprise::playback.
set(REPRISE_INSTALLED_TARGETS reprise_options)
foreach(part base package vulkan playback)
  set_target_properties(reprise_${part} PROPERTIES EXPORT_NAME ${part})
  list(APPEND REPRISE_INSTALLED_TARGETS reprise_${part})
endforeach()
target_compile_features(reprise_base PUBLIC cxx_std_20)

install(TARGETS ${REPRISE_INSTALLED_TARGETS} EXPORT RepriseTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        INCLUDES DESTINATION ${REPRISE_INSTALL_INCLUDE})
install(EXPORT RepriseTargets NAMESPACE Reprise:: DESTINATION ${REPRISE_INSTALL_CMAKE})

foreach(header
    runtime/base/check.h runtime/base/file.h runtime/base/hash.h runtime/base/result.h
    runtime/package/embedded.h runtime/package/interface.h runtime/package/package.h runtime/package/recipe.h
    runtime/playback/player.h runtime/vulkan/lane_probe.h)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${REPRISE_INSTALL_INCLUDE}/${folder})
endforeach()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/RepriseConfig.cmake.in
  ${PROJECT_BINARY_DIR}/cmake/RepriseConfig.cmake INSTALL_DESTINATION ${REPRISE_INSTALL_CMAKE})
# Package formats may change with any version below 1.0: SameMinorVersion says so.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/RepriseConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cmake/RepriseConfig.cmake ${PROJECT_BINARY_DIR}/cmake/RepriseConfigVersion.cmake
        DESTINATION ${REPRISE_INSTALL_CMAKE})
install(FILES ${PROJECT_SOURCE_DIR}/cmake/RepriseOptimizeShader.cmake ${PROJECT_SOURCE_DIR}/cmake/reprise_build_step.cmake
        DESTINATION ${REPRISE_INSTALL_CMAKE})

# For Makefiles: pkg-config --variable=reprise reprise, pkg-config --cflags --libs --static reprise
# Its prefix is told from where it lies, so that an installed tree can be moved.
file(RELATIVE_PATH REPRISE_PC_PREFIX /root/${CMAKE_INSTALL_LIBDIR}/pkgconfig /root)
configure_file(${CMAKE_CURRENT_LIST_DIR}/reprise.pc.in ${PROJECT_BINARY_DIR}/cmake/reprise.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/cmake/reprise.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

if(TARGET reprise)
  install(TARGETS reprise EXPORT RepriseTargets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(FILES ${PROJECT_SOURCE_DIR}/docs/reprise.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${PROJECT_SOURCE_DIR}/cli/completion/reprise.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME reprise)
  install(FILES ${PROJECT_SOURCE_DIR}/cli/completion/_reprise DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
endif()
include(${CMAKE_CURRENT_LIST_DIR}/deb.cmake)
