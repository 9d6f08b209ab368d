#pragma once

#include <QString>
#include <QStringList>

#include <algorithm>
#include <array>
#include <vector>

namespace rubble::test {

/// What a system demands of the name of a file or folder: one row of the table in docs/formats/names.md. Written with
/// Qt's Unicode tables, not with those of the code that makes the names.
struct NameRule {
    const char* rule;
    bool (*isKept)(const QString& name);
};

inline bool containsNone(const QString& name, const QString& characters) {
    return std::ranges::none_of(name, [&](QChar one) { return characters.contains(one); });
}

/// Windows looks at what comes before the first dot, without spaces behind it.
inline bool isWindowsDevice(const QString& name) {
    QString start = name.section('.', 0, 0).toUpper();
    while (start.endsWith(' ')) start.chop(1);
    QStringList devices{"CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$"};
    for (const char* device : {"COM", "LPT"}) {
        for (const QChar digit : QString::fromUtf8("0123456789¹²³")) devices.append(device + QString(digit));
    }
    return devices.contains(start);
}

inline const std::array<NameRule, 10>& nameRules() {
    static const std::array<NameRule, 10> rules = {{
        {"Windows: no < > : \" / \\ | ? *", [](const QString& name) { return containsNone(name, "<>:\"/\\|?*"); }},
        {"Windows: no control characters",
         [](const QString& name) { return std::ranges::none_of(name, [](QChar one) { return one < ' '; }); }},
        {"Windows: neither a space nor a period at the end",
         [](const QString& name) { return !name.endsWith(' ') && !name.endsWith('.'); }},
        {"Windows: not the name of a device, with any ending",
         [](const QString& name) { return !isWindowsDevice(name); }},
        {"Windows: at most 255 UTF-16 units", [](const QString& name) { return name.size() <= 255; }},
        {"macOS: well-formed UTF-8",
         [](const QString& name) { return name.isValidUtf16() && !name.contains(QChar::ReplacementCharacter); }},
        {"macOS: no : or /", [](const QString& name) { return containsNone(name, ":/"); }},
        {"macOS: at most 255 UTF-16 units in normalization form D",
         [](const QString& name) { return name.normalized(QString::NormalizationForm_D).size() <= 255; }},
        {"Linux: no / and no null character",
         [](const QString& name) { return containsNone(name, QString("/") + QChar(0)); }},
        {"Linux, macOS: 1 to 255 bytes, not . or ..",
         [](const QString& name) {
             const qsizetype size = name.toUtf8().size();
             return size > 0 && size <= 255 && name != "." && name != "..";
         }},
    }};
    return rules;
}

/// The rules that a name breaks.
inline QStringList brokenNameRules(const QString& name) {
    QStringList broken;
    for (const NameRule& one : nameRules()) {
        if (!one.isKept(name)) broken.append(one.rule);
    }
    return broken;
}

/// A way in which a file system compares names: those with equal keys are one.
using NameComparison = QString (*)(const QString& name);

/// NTFS: in upper case, character by character. APFS, and folders of ext4 that ignore case: case and normalization
/// ignored. HFS+: as APFS, without the characters that it skips.
inline const std::vector<NameComparison>& nameComparisons() {
    static const std::vector<NameComparison> comparisons = {
        [](const QString& name) {
            QString key;
            for (const char32_t code : name.toUcs4())
                key += QString::fromUcs4(std::array{QChar::toUpper(code)}.data(), 1);
            return key;
        },
        [](const QString& name) {
            // Upper case first: Qt folds "ß" only there.
            const QString upper = name.normalized(QString::NormalizationForm_D).toUpper();
            return upper.toCaseFolded().normalized(QString::NormalizationForm_D);
        },
        [](const QString& name) {
            QString key = name.normalized(QString::NormalizationForm_D).toLower();
            key.removeIf([](QChar one) {
                const char16_t code = one.unicode();
                return (code >= 0x200C && code <= 0x200F) || (code >= 0x202A && code <= 0x202E) ||
                       (code >= 0x206A && code <= 0x206F) || code == 0xFEFF;
            });
            return key;
        },
    };
    return comparisons;
}

/// Two of the names that are one on some system; empty if there are none.
inline QStringList sameNames(const QStringList& names) {
    for (const NameComparison& key : nameComparisons()) {
        for (qsizetype k = 0; k < names.size(); ++k) {
            for (qsizetype other = k + 1; other < names.size(); ++other) {
                if (key(names[k]) == key(names[other])) return {names[k], names[other]};
            }
        }
    }
    return {};
}

}  // namespace rubble::test
