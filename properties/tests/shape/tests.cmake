# The same short names as in the other files, for 50 digits instead of double.
set_source_files_properties(${folder}/fifty_digits.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
