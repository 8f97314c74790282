# Its helpers are overloads of those of families.cpp.
set_source_files_properties(${folder}/hard.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
