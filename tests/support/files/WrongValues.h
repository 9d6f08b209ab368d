#pragma once

#include "tests/support/files/JsonMutations.h"

#include <QTest>

#include <nlohmann/json.hpp>
#include <string>

// Data of a test that puts wrong values into a JSON document, one per row; a row is named after the expected error.

namespace rubble::test {

inline void addWrongValueColumns() {
    QTest::addColumn<QString>("pointer");
    QTest::addColumn<QString>("value");
}

inline void addWrongValue(const char* error, const char* pointer, const char* value) {
    QTest::newRow(error) << QString(pointer) << QString(value);
}

/// Returns the text of a document with the wrong value of the current row.
inline std::string withWrongValue(const nlohmann::json& document) {
    QFETCH(QString, pointer);
    QFETCH(QString, value);
    return changedText(document, pointer.toStdString(), value.toStdString());
}

}  // namespace rubble::test
