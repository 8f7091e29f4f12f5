#include "Formats/Gzip.h"

#include <zlib.h>

#include <algorithm>

#include "Core/base/Error.h"

namespace authalic {

std::vector<std::uint8_t> gzipped(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw FormatError(path, "There is no memory left to compress the file.");
  }
  std::vector<std::uint8_t> packed;
  std::vector<std::uint8_t> out(1U << 20);
  std::size_t at = 0;
  int code = Z_OK;
  while (code != Z_STREAM_END) {
    const std::size_t count = std::min<std::size_t>(bytes.size() - at, 1U << 24);
    stream.next_in = const_cast<Bytef*>(bytes.data()) + at;
    stream.avail_in = static_cast<uInt>(count);
    stream.next_out = out.data();
    stream.avail_out = static_cast<uInt>(out.size());
    code = deflate(&stream, at + count == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
    at += count - stream.avail_in;
    packed.insert(packed.end(), out.begin(), out.end() - static_cast<std::ptrdiff_t>(stream.avail_out));
  }
  deflateEnd(&stream);
  return packed;
}

}  // namespace authalic
