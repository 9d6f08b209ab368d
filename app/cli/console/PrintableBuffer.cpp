#include "app/cli/console/PrintableBuffer.h"

#include "core/base/MessageText.h"

namespace rubble {

PrintableBuffer::int_type PrintableBuffer::overflow(int_type letter) {
    if (traits_type::eq_int_type(letter, traits_type::eof())) return 0;
    m_text += traits_type::to_char_type(letter);
    return letter;
}

int PrintableBuffer::sync() {
    m_target << printableText(m_text) << std::flush;
    m_text.clear();
    return m_target ? 0 : -1;
}

}  // namespace rubble
