#pragma once

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rubble::test {

/// Ends a program that was called wrongly.
[[noreturn]] inline void failWith(const std::string& message) {
    std::fprintf(stderr, "%s\n", message.c_str());
    std::exit(2);
}

/// The options of a test program, and where what is given for each is stored:
///
///     ProgramOptions(kUsage).flag("--verbose", isVerbose).value("--seed", seed).read(argumentCount, arguments);
class ProgramOptions {
public:
    /// `usage` is printed where an option is not known.
    explicit ProgramOptions(std::string usage) : m_usage(std::move(usage)) {}

    /// An option without a value, which sets `target`.
    ProgramOptions& flag(const std::string& name, bool& target) {
        m_flags[name] = &target;
        return *this;
    }
    /// An option with a value: a number, a text or a path. A list gets the values of all that are given.
    template <class Value>
    ProgramOptions& value(const std::string& name, Value& target) {
        m_values[name] = [&target](const char* text) { return isStored(text, target); };
        return *this;
    }

    /// Stores what is given. Ends the program with a message where that cannot be read.
    void read(int argumentCount, char** arguments) const {
        for (int k = 1; k < argumentCount; ++k) {
            const std::string name = arguments[k];
            if (const auto flag = m_flags.find(name); flag != m_flags.end()) {
                *flag->second = true;
                continue;
            }
            const auto value = m_values.find(name);
            if (value == m_values.end()) failWith(m_usage);
            if (++k == argumentCount) failWith(name + " needs a value.");
            if (!value->second(arguments[k])) failWith(name + " needs a number, not \"" + arguments[k] + "\".");
        }
    }

private:
    static bool isStored(const char* text, std::string& target) {
        target = text;
        return true;
    }
    static bool isStored(const char* text, std::filesystem::path& target) {
        target = text;
        return true;
    }
    static bool isStored(const char* text, std::vector<std::string>& target) {
        target.emplace_back(text);
        return true;
    }
    template <class Number>
    static bool isStored(const char* text, Number& target) {
        const char* const end = text + std::strlen(text);
        const auto [rest, error] = std::from_chars(text, end, target);
        return error == std::errc{} && rest == end;
    }

    std::string m_usage;
    std::map<std::string, bool*> m_flags;
    std::map<std::string, std::function<bool(const char*)>> m_values;
};

}  // namespace rubble::test
