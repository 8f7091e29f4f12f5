/// @file
/// VTK's XML files of poly data, read here: VTK's own reader does not survive damaged ones. Private to IOSurface/.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

namespace authalic {

/// Reads a .vtp file of one or several pieces: ASCII, binary or appended arrays, base64 or raw, either byte order,
/// uncompressed or compressed with zlib, LZ4 or LZMA; point, cell and field arrays with their active attributes, text
/// among the fields. Information keys are passed over.
///
/// Guarantees: every array has as many values as its place asks for, offsets of cells rise to the length of the
/// corners, and memory is bounded by the bytes of the file.
/// @throws FormatError
void readVtp(const std::string& path, const std::vector<std::uint8_t>& bytes, vtkPolyData* output);

}  // namespace authalic
