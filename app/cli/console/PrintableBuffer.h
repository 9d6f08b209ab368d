#pragma once

#include <ostream>
#include <streambuf>
#include <string>

namespace rubble {

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
