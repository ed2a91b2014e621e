// No code of its own: CMakeLists.txt has headers read here once for the tests of the window.
