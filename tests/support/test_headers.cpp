// Nothing: the headers that most tests include are compiled for this source, and used by others
// (tests/CMakeLists.txt).
