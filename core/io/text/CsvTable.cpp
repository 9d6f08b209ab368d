#include "core/io/text/CsvTable.h"

#include "core/base/Assert.h"
#include "core/io/text/NumberText.h"

#include <algorithm>
#include <utility>

namespace rubble {

std::string csvField(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string field = "\"";
    for (const char letter : text) field.append(letter == '"' ? 2 : 1, letter);
    return field + '"';
}

CsvTable::CsvTable(std::span<const std::string> columns) : m_columns(columns), m_fields(columns.size()) {
    for (std::size_t k = 0; k < columns.size(); ++k) m_fields[k] = csvField(columns[k]);
    addRow();
}

/// Appends a key, or the index of the next element, to the path.
void CsvTable::enter(std::string_view key) {
    if (m_open.empty()) return;
    if (m_open.back().isArray) {
        m_path += '[' + std::to_string(m_open.back().count++) + ']';
        return;
    }
    if (!m_path.empty()) m_path += '.';
    m_path += key;
}

void CsvTable::open(std::string_view key, bool isArray) {
    const std::size_t length = m_path.size();
    enter(key);
    m_open.push_back({length, isArray});
}

void CsvTable::openObject(std::string_view key) { open(key, false); }
void CsvTable::openArray(std::string_view key) { open(key, true); }

void CsvTable::close() {
    RUBBLE_ASSERT(!m_open.empty());
    m_path.resize(m_open.back().pathLength);
    m_open.pop_back();
    if (m_open.empty()) addRow();
}

void CsvTable::setField(std::string_view key, std::string field) {
    const std::size_t length = m_path.size();
    enter(key);
    const auto after = m_columns.begin() + static_cast<std::ptrdiff_t>(m_nextColumn);
    auto column = std::find(after, m_columns.end(), m_path);
    if (column == m_columns.end()) column = std::find(m_columns.begin(), after, m_path);
    RUBBLE_ASSERT(column != m_columns.end() && *column == m_path);
    m_nextColumn = static_cast<std::size_t>(column - m_columns.begin()) + 1;
    m_fields[m_nextColumn - 1] = std::move(field);
    m_path.resize(length);
}

void CsvTable::addRow() {
    for (std::size_t k = 0; k < m_fields.size(); ++k) {
        if (k > 0) m_text += ',';
        m_text += std::exchange(m_fields[k], {});
    }
    m_text += '\n';
    m_nextColumn = 0;
}

void CsvTable::number(std::string_view key, double value) { setField(key, numberText(value)); }
void CsvTable::wholeNumber(std::string_view key, std::uint64_t value) { setField(key, std::to_string(value)); }
void CsvTable::text(std::string_view key, std::string_view value) { setField(key, csvField(value)); }

void CsvTable::numbers(std::string_view key, std::initializer_list<double> values) {
    openArray(key);
    for (const double value : values) number({}, value);
    close();
}

void CsvTable::wholeNumbers(std::string_view key, std::span<const std::uint32_t> values) {
    openArray(key);
    for (const std::uint32_t value : values) wholeNumber({}, value);
    close();
}

std::string CsvTable::finished() && {
    RUBBLE_ASSERT(m_open.empty());
    return std::move(m_text);
}

}  // namespace rubble
