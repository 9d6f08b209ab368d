#include "core/base/Hash.h"

#include <xxhash.h>

#include <bit>
#include <charconv>

namespace rubble {

static_assert(std::endian::native == std::endian::little, "hashing reads numbers as little-endian bytes");

struct Hasher::State {
    XXH3_state_t* xxh = XXH3_createState();
    State() { XXH3_128bits_reset(xxh); }
    ~State() { XXH3_freeState(xxh); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

std::string ContentHash::hex() const {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string text(32, '0');
    for (int i = 0; i < 16; ++i) {
        text[15 - i] = kDigits[(high >> (4 * i)) & 15];
        text[31 - i] = kDigits[(low >> (4 * i)) & 15];
    }
    return text;
}

std::optional<ContentHash> parseContentHash(std::string_view hex) {
    ContentHash hash;
    const auto read = [&](std::size_t from, std::uint64_t& half) {
        const char* end = hex.data() + from + 16;
        return std::from_chars(hex.data() + from, end, half, 16).ptr == end;
    };
    if (hex.size() != 32 || !read(0, hash.high) || !read(16, hash.low)) return std::nullopt;
    return hash;
}

Hasher::Hasher() : m_state(std::make_unique<State>()) {}
Hasher::~Hasher() = default;
Hasher::Hasher(Hasher&&) noexcept = default;
Hasher& Hasher::operator=(Hasher&&) noexcept = default;

void Hasher::add(std::string_view bytes) { XXH3_128bits_update(m_state->xxh, bytes.data(), bytes.size()); }
void Hasher::add(std::span<const std::byte> bytes) { XXH3_128bits_update(m_state->xxh, bytes.data(), bytes.size()); }
void Hasher::add(std::uint64_t value) { XXH3_128bits_update(m_state->xxh, &value, sizeof value); }
void Hasher::add(double value) { add(std::bit_cast<std::uint64_t>(value)); }

ContentHash Hasher::digest() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(m_state->xxh);
    return {hash.high64, hash.low64};
}

ContentHash contentHash(std::string_view bytes) {
    const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
    return {hash.high64, hash.low64};
}

}  // namespace rubble
