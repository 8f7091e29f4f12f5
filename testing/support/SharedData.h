/// @file
/// Where real test data lie, and a visible skip where they do not.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace authalic::testing {

/// Path below the folder of real data; AUTHALIC_SHARED_DATA in the environment overrides the configured one.
inline std::string sharedData(const std::string& relative) {
  const char* fromEnvironment = std::getenv("AUTHALIC_SHARED_DATA");
  return std::string(fromEnvironment ? fromEnvironment : AUTHALIC_SHARED_DATA) + "/" + relative;
}

/// Path below data/.
inline std::string fixture(const std::string& relative) { return std::string(AUTHALIC_FIXTURES) + "/" + relative; }

}  // namespace authalic::testing

/// Skips the test, saying which file is missing, when a file of the real data is not there.
#define AUTHALIC_NEEDS(path)                                                     \
  if (!std::filesystem::exists(path)) {                                          \
    GTEST_SKIP() << "real data not present: " << (path);                         \
  }                                                                              \
  static_assert(true, "")
