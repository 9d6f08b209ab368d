#pragma once

#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

namespace rubble {

/// Returns text that cannot control a terminal: control characters except line feeds and tabs, Unicode direction marks,
/// and bytes that are not UTF-8 become "\\u001b" or "\\x9b".
std::string printableText(std::string_view text);

/// Passes printableText() of what is written on to another stream when it is flushed. Names in files can hold any
/// character.
class PrintableBuffer : public std::streambuf {
public:
    explicit PrintableBuffer(std::ostream& target) : m_target(target) {}
    ~PrintableBuffer() override { PrintableBuffer::sync(); }

private:
    int_type overflow(int_type letter) override;
    int sync() override;

    std::ostream& m_target;
    std::string m_text;  // since the last flush
};

}  // namespace rubble
