# Installs this build into a folder of its own and builds examples/embed against it, as a user would:
#   cmake -DBUILD=... -DSOURCE=... -DPREFIX=... -DEXAMPLE=... -DGENERATOR=... -DCOMPILER=... -DCONFIG=... -P build_example.cmake
# Says nothing where all goes well.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}: ${status}\n${output}")
  endif()
endfunction()

# What an earlier version installed must not help.
file(REMOVE_RECURSE ${PREFIX})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX})
run(${CMAKE_COMMAND} -S ${SOURCE}/examples/embed -B ${EXAMPLE} -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${PREFIX}
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=${CONFIG})
run(${CMAKE_COMMAND} --build ${EXAMPLE})
