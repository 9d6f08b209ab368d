#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rubble {

/// A 128-bit content hash, the same on every machine. Not cryptographic.
struct ContentHash {
    std::uint64_t high = 0;
    std::uint64_t low = 0;
    bool operator==(const ContentHash&) const = default;
    /// 32 lower-case hexadecimal digits.
    std::string hex() const;
};

/// Parses the text of ContentHash::hex(); nothing for any other text.
std::optional<ContentHash> parseContentHash(std::string_view hex);

/// Hashes a sequence of bytes and numbers incrementally. Numbers are hashed as their little-endian bytes.
/// Source: XXH3, 128 bits (libxxhash).
class Hasher {
public:
    Hasher();
    ~Hasher();
    Hasher(Hasher&&) noexcept;
    Hasher& operator=(Hasher&&) noexcept;

    void add(std::string_view bytes);
    void add(std::span<const std::byte> bytes);
    void add(std::uint64_t value);
    void add(double value);
    ContentHash digest() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

/// The hash of bytes in one call.
ContentHash contentHash(std::string_view bytes);

}  // namespace rubble
