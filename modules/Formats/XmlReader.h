/// @file
/// Walks an XML document with expat: what the GIFTI, CIFTI and VTK readers share.
#pragma once

#include <cstdint>
#include <exception>
#include <map>
#include <string>
#include <string_view>

struct XML_ParserStruct;

namespace authalic {

using XmlAttributes = std::map<std::string, std::string>;

/// `text` without blanks at either end.
[[nodiscard]] std::string trimmed(const std::string& text);

/// Calls start() and end() for every element; in either text_ holds the characters since the last of both.
///
/// Exceptions thrown by either stop the C library and leave walk(). A document that declares entities is
/// refused, because one that expands them can fill any memory.
class XmlReader {
 public:
  explicit XmlReader(const std::string& path) : path_(path) {}
  virtual ~XmlReader() = default;
  XmlReader(const XmlReader&) = delete;
  XmlReader& operator=(const XmlReader&) = delete;

 protected:
  /// @throws FormatError when the XML is not well formed or ends early
  void walk(std::string_view document);
  virtual void start(const std::string& element, const XmlAttributes& attributes) = 0;
  virtual void end(const std::string& element) = 0;
  /// Place in the document; 0 outside walk().
  [[nodiscard]] std::int64_t byteIndex() const;

  const std::string& path_;
  std::string text_;

 private:
  struct Events;
  XML_ParserStruct* parser_ = nullptr;
  std::exception_ptr failure_;
};

}  // namespace authalic
