#pragma once

#include <clocale>
#include <locale>
#include <string>

namespace rubble {

/// While it lives, the program runs where 1234.5 is written "1.234,5": for the C library as far as such a locale is
/// installed, for streams always.
class CommaLocale {
public:
    CommaLocale() : m_cLocale(std::setlocale(LC_ALL, nullptr)) {
        const std::locale streams(std::locale(), new Commas);
        m_streams = std::locale::global(streams);
        std::setlocale(LC_ALL, "de_DE.UTF-8");
    }
    ~CommaLocale() {
        std::locale::global(m_streams);
        std::setlocale(LC_ALL, m_cLocale.c_str());
    }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;

private:
    struct Commas : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    std::string m_cLocale;
    std::locale m_streams;
};

}  // namespace rubble
