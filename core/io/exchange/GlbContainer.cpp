#include "core/io/exchange/GlbContainer.h"

#include <cstddef>
#include <cstdint>

namespace rubble {
namespace {

constexpr std::uint32_t kMagic = 0x46546c67;  // "glTF"
constexpr std::uint32_t kGlbVersion = 2;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004e4942;  // "BIN"

void appendWord(std::string& bytes, std::size_t number) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 255);
}

void fillUp(std::string& bytes, char with) { bytes.resize((bytes.size() + 3) / 4 * 4, with); }

}  // namespace

std::string glbContainer(std::string json, std::string binary) {
    fillUp(json, ' ');
    fillUp(binary, '\0');
    std::string bytes;
    bytes.reserve(28 + json.size() + binary.size());
    appendWord(bytes, kMagic);
    appendWord(bytes, kGlbVersion);
    appendWord(bytes, 28 + json.size() + binary.size());
    appendWord(bytes, json.size());
    appendWord(bytes, kJsonChunk);
    bytes += json;
    appendWord(bytes, binary.size());
    appendWord(bytes, kBinaryChunk);
    bytes += binary;
    return bytes;
}

}  // namespace rubble
