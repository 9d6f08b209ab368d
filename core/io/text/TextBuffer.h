#pragma once

#include "core/base/Assert.h"

#include <array>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace rubble {

/// Builds a long text from many short ones: these are written to a small block that stays in the processor's cache and
/// is appended to the text when it is full.
class TextBuffer {
public:
    /// Reserves memory for a text of `expectedSize` bytes.
    explicit TextBuffer(std::size_t expectedSize = 0) { m_text.reserve(expectedSize); }
    TextBuffer(const TextBuffer&) = delete;
    TextBuffer& operator=(const TextBuffer&) = delete;

    /// Returns where to write up to `size` bytes, at most kBlockSize; setEnd() then says how many were written.
    char* reserve(std::size_t size) {
        RUBBLE_ASSERT(size <= kBlockSize);
        if (size > static_cast<std::size_t>(m_block.data() + kBlockSize - m_end)) flush();
        return m_end;
    }
    void setEnd(char* end) { m_end = end; }

    void append(char letter) {
        *reserve(1) = letter;
        ++m_end;
    }
    void append(std::string_view text) {
        if (text.size() > kBlockSize) {
            flush();
            m_text += text;
            return;
        }
        char* const at = reserve(text.size());
        std::memcpy(at, text.data(), text.size());
        m_end = at + text.size();
    }

    std::string text() && {
        flush();
        return std::move(m_text);
    }

private:
    static constexpr std::size_t kBlockSize = 8192;

    void flush() {
        m_text.append(m_block.data(), m_end);
        m_end = m_block.data();
    }

    std::string m_text;
    std::array<char, kBlockSize> m_block;
    char* m_end = m_block.data();
};

}  // namespace rubble
