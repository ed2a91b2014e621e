// Compiles the headers that most tests include. Other sources use the result
// (tests/CMakeLists.txt).
