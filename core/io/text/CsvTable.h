#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// A text as a field of CSV: in quotes if it has a comma, a quote or a line end, with its quotes doubled (RFC 4180).
std::string csvField(std::string_view text);

/// Writes objects as rows of CSV, by the calls with which JsonWriter writes them as JSON. A value is in the column that
/// is named as its place in the object: "energy", "point[1]", "omitted.impact.count". Columns that an object does not
/// have are empty. Numbers are those of JsonWriter.
class CsvTable {
public:
    /// `columns` is constant: names, in their order.
    explicit CsvTable(std::span<const std::string> columns);

    void openObject(std::string_view key = {});
    void openArray(std::string_view key = {});
    /// Closes the object or array that was opened last. The outermost object becomes a row.
    void close();
    void number(std::string_view key, double value);
    void wholeNumber(std::string_view key, std::uint64_t value);
    void text(std::string_view key, std::string_view value);
    void numbers(std::string_view key, std::initializer_list<double> values);
    void wholeNumbers(std::string_view key, std::span<const std::uint32_t> values);

    /// The rows, each with a line feed at its end, after a row of names.
    std::string finished() &&;

private:
    struct Container {
        std::size_t pathLength;  // of the path without it
        bool isArray;
        std::size_t count = 0;  // elements so far
    };
    void open(std::string_view key, bool isArray);
    void enter(std::string_view key);
    void setField(std::string_view key, std::string field);
    void addRow();

    std::span<const std::string> m_columns;
    std::vector<std::string> m_fields;  // of the row, by column
    std::size_t m_nextColumn = 0;       // after the one that was set last: values mostly come in order
    std::string m_path;
    std::vector<Container> m_open;  // outermost first
    std::string m_text;
};

}  // namespace rubble
