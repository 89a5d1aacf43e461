// Included before each test of tools under sanitizers: the body of a test runs once, and its
// optimization takes a third of the time that the file takes to be compiled. Templates of the
// precompiled headers are optimized as ever. Tests of vo and synth go over pixels, which takes
// longer without.
#pragma clang optimize off
