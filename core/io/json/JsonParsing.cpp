#include "core/base/MessageText.h"
#include "core/io/json/JsonDocument.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

namespace rubble {
namespace {

constexpr std::size_t kMaxDepth = 64;  // our own formats nest a dozen levels

struct TextPosition {
    std::size_t line = 1;
    std::size_t column = 1;
};

/// Returns line and column of the byte before `position`; both count from 1.
TextPosition textPosition(std::string_view text, std::size_t position) {
    TextPosition result;
    const std::string_view before = text.substr(0, position == 0 ? 0 : position - 1);
    result.line += static_cast<std::size_t>(std::ranges::count(before, '\n'));
    const std::size_t lineStart = before.rfind('\n');
    result.column += before.size() - (lineStart == std::string_view::npos ? 0 : lineStart + 1);
    return result;
}

/// Returns the library's message without its prefix and the bytes it read last: "unexpected ']'; expected ...".
std::string parserReason(std::string_view message) {
    if (message.find("number overflow") != std::string_view::npos) return "a number is too large";
    const std::size_t start = message.find(" - ");
    if (start != std::string_view::npos) message.remove_prefix(start + 3);
    const std::size_t lastRead = message.find("; last read: '");
    return std::string(message.substr(0, lastRead));
}

}  // namespace

Status checkJsonSize(std::string_view text) {
    if (text.size() > kMaxJsonSize)
        return Error{ErrorCode::Limit, "The JSON is larger than 256 MiB: " + std::to_string(text.size()) + " bytes."};
    // Each value but the first follows one of these; those in texts are few.
    const auto beginsValue = [](char letter) { return letter == ',' || letter == '[' || letter == '{'; };
    if (std::cmp_greater_equal(std::ranges::count_if(text, beginsValue), kMaxJsonValues))
        return Error{ErrorCode::Limit, "The JSON has more than " + std::to_string(kMaxJsonValues) + " values."};
    return success();
}

/// Receives the parser's events and appends a node for each value.
class JsonDocument::Builder {
public:
    Builder(JsonDocument& document, std::string_view text) : m_document(document), m_text(text) {}

    bool null() { return add(Kind::Null, 0); }
    bool boolean(bool value) { return add(value ? Kind::True : Kind::False, 0); }
    bool number_integer(std::int64_t value) { return add(Kind::Negative, std::bit_cast<std::uint64_t>(value)); }
    bool number_unsigned(std::uint64_t value) { return add(Kind::Unsigned, value); }
    bool number_float(double value, const std::string&) { return add(Kind::Real, std::bit_cast<std::uint64_t>(value)); }
    bool string(std::string& value) { return add(Kind::Text, store(value)); }
    bool binary(std::vector<std::uint8_t>&) { return false; }  // JSON text has none
    bool key(std::string& value) {
        m_key = store(value);
        return true;
    }
    bool start_object(std::size_t) { return open(Kind::Object); }
    bool start_array(std::size_t) { return open(Kind::Array); }
    bool end_array() { return close(); }
    bool end_object() { return close() && checkKeysAreUnique(static_cast<std::uint32_t>(m_last)); }

    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) {
        const TextPosition at = textPosition(m_text, position);
        return refuse({ErrorCode::BadInput, "The text is not JSON at line " + std::to_string(at.line) + ", column " +
                                                std::to_string(at.column) + ": " + parserReason(error.what()) + "."});
    }

private:
    bool refuse(Error error) {
        m_document.m_error = std::move(error);
        return false;
    }

    std::uint32_t store(const std::string& text) {
        const auto at = static_cast<std::uint32_t>(m_document.m_texts.size());
        const auto length = static_cast<std::uint32_t>(text.size());
        char bytes[sizeof length];
        std::memcpy(bytes, &length, sizeof length);
        m_document.m_texts.append(bytes, sizeof length).append(text);
        return at;
    }

    bool add(Kind kind, std::uint64_t bits) {
        std::vector<Node>& nodes = m_document.m_nodes;
        if (!m_open.empty()) ++nodes[m_open.back()].count;
        nodes.push_back({bits, m_key, static_cast<std::uint32_t>(nodes.size() + 1), 0, kind});
        return true;
    }

    bool open(Kind kind) {
        if (m_open.size() == kMaxDepth) {
            return refuse(
                {ErrorCode::Limit, "The JSON is nested deeper than " + std::to_string(kMaxDepth) + " levels."});
        }
        add(kind, 0);
        m_open.push_back(static_cast<std::uint32_t>(m_document.m_nodes.size() - 1));
        m_document.m_nodes.back().end = 0xffffffffu;  // until it is closed: all that follows is inside
        return true;
    }

    bool close() {
        m_last = m_open.back();
        m_open.pop_back();
        m_document.m_nodes[m_last].end = static_cast<std::uint32_t>(m_document.m_nodes.size());
        return true;
    }

    bool checkKeysAreUnique(std::uint32_t object) {
        const std::vector<Node>& nodes = m_document.m_nodes;
        m_keys.clear();
        for (std::uint32_t child = object + 1; child < nodes[object].end; child = nodes[child].end)
            m_keys.push_back(m_document.textAt(nodes[child].key));
        std::ranges::sort(m_keys);
        const auto repeated = std::ranges::adjacent_find(m_keys);
        if (repeated == m_keys.end()) return true;
        return refuse(m_document.errorAt(object, "the key " + quotedName(*repeated) + " is repeated"));
    }

    JsonDocument& m_document;
    std::string_view m_text;
    std::vector<std::uint32_t> m_open;  // containers, outermost first
    std::uint32_t m_key = 0;
    std::uint32_t m_last = 0;  // the container closed last
    std::vector<std::string_view> m_keys;
};

Result<JsonDocument> JsonDocument::parse(std::string_view text) {
    if (const Status fits = checkJsonSize(text); !fits) return fits.error();
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        return Error{ErrorCode::BadInput, "The text is empty; it should be JSON."};
    if (const std::size_t null = text.find('\0'); null != std::string_view::npos) {  // the library would stop there
        const TextPosition at = textPosition(text, null + 1);
        return Error{ErrorCode::BadInput, "The text is not JSON at line " + std::to_string(at.line) + ", column " +
                                              std::to_string(at.column) + ": it contains a byte of value 0."};
    }
    JsonDocument document;
    Builder builder(document, text);
    if (!nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) return *document.m_error;
    return document;
}

JsonValue JsonDocument::root() { return {this, 0}; }

std::string_view JsonDocument::textAt(std::uint64_t at) const {
    std::uint32_t length = 0;
    std::memcpy(&length, m_texts.data() + at, sizeof length);
    return std::string_view(m_texts).substr(at + sizeof length, length);
}

}  // namespace rubble
