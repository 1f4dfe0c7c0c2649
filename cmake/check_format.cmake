# Fails where a source differs from what .clang-format asks for.
# usage: cmake -DCLANG_FORMAT=<program> -DSOURCE_DIR=<package> -P check_format.cmake
set(globs)
foreach(folder include lab src test)
  foreach(extension h cpp cc)
    list(APPEND globs ${SOURCE_DIR}/${folder}/*.${extension})
  endforeach()
endforeach()
file(GLOB_RECURSE files ${globs})
execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${files} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "run clang-format -i on the files named above")
endif()
