#include "Formats/XmlReader.h"

#include <expat.h>

#include <algorithm>
#include <memory>

#include "Core/base/Error.h"

namespace authalic {

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t\r\n");
  const auto end = text.find_last_not_of(" \t\r\n");
  return begin == std::string::npos ? std::string() : text.substr(begin, end - begin + 1);
}

/// The functions that expat calls. Exceptions are kept and rethrown outside the C library.
struct XmlReader::Events {
  template <class Action>
  static void guarded(void* data, Action action) noexcept {
    XmlReader& reader = *static_cast<XmlReader*>(data);
    if (reader.failure_) {
      return;
    }
    try {
      action(reader);
    } catch (...) {
      reader.failure_ = std::current_exception();
      XML_StopParser(reader.parser_, XML_FALSE);
    }
  }
  static void XMLCALL onStart(void* data, const XML_Char* name, const XML_Char** pairs) {
    guarded(data, [&](XmlReader& reader) {
      XmlAttributes attributes;
      for (; pairs[0] != nullptr; pairs += 2) {
        attributes[pairs[0]] = pairs[1];
      }
      reader.start(name, attributes);
      reader.text_.clear();
    });
  }
  static void XMLCALL onEnd(void* data, const XML_Char* name) {
    guarded(data, [&](XmlReader& reader) {
      reader.end(name);
      reader.text_.clear();
    });
  }
  static void XMLCALL onText(void* data, const XML_Char* text, int length) {
    guarded(data, [&](XmlReader& reader) { reader.text_.append(text, static_cast<std::size_t>(length)); });
  }
  static void XMLCALL onEntity(void* data, const XML_Char*, int, const XML_Char*, int, const XML_Char*,
                               const XML_Char*, const XML_Char*, const XML_Char*) {
    guarded(data, [](XmlReader& reader) {
      throw FormatError(reader.path_,
                        "Files of this kind define no XML entities, but this one does; it is not trusted.");
    });
  }
};

void XmlReader::walk(std::string_view document) {
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> owner(XML_ParserCreate(nullptr),
                                                                         XML_ParserFree);
  const std::unique_ptr<XML_ParserStruct*, void (*)(XML_ParserStruct**)> forget(
      &parser_, [](XML_ParserStruct** parser) { *parser = nullptr; });
  parser_ = owner.get();
  XML_SetUserData(parser_, this);
  XML_SetElementHandler(parser_, &Events::onStart, &Events::onEnd);
  XML_SetCharacterDataHandler(parser_, &Events::onText);
  XML_SetEntityDeclHandler(parser_, &Events::onEntity);
  constexpr std::size_t chunk = 1U << 24;
  std::size_t at = 0;
  do {
    const std::size_t count = std::min(chunk, document.size() - at);
    const bool last = at + count == document.size();
    const auto status = XML_Parse(parser_, document.data() + at, static_cast<int>(count), last ? 1 : 0);
    if (failure_) {
      std::rethrow_exception(failure_);
    }
    if (status != XML_STATUS_OK) {
      throw FormatError(path_,
                        std::string("The XML is not well formed (") +
                            XML_ErrorString(XML_GetErrorCode(parser_)) +
                            "); the file is damaged or truncated.",
                        byteIndex());
    }
    at += count;
  } while (at < document.size());
}

std::int64_t XmlReader::byteIndex() const { return parser_ ? XML_GetCurrentByteIndex(parser_) : 0; }

}  // namespace authalic
