#include "core/io/formats/ExportOption.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <set>

using namespace rubble;

class ExportOptionTest : public QObject {
    Q_OBJECT
private slots:
    void valuesAreReadAsSet() {
        std::set<std::string_view> words;
        for (const ExportOption* option : exportOptions()) {
            words.insert(option->word);
            PackOptions options;
            for (std::size_t value = 0; value < option->values.size(); ++value) {
                option->set(options, value);
                QCOMPARE(option->get(options), value);
                QCOMPARE(valueNamed(*option, option->values[value].word), std::optional(value));
            }
            QVERIFY(!valueNamed(*option, "stone"));
            QVERIFY(option->caption.empty() || !option->hint.empty());
        }
        QCOMPARE(words.size(), exportOptions().size());
    }
    /// Else two rows would change one member.
    void eachOptionIsItsOwn() {
        for (const ExportOption* one : exportOptions()) {
            PackOptions changed;
            one->set(changed, one->get(changed) == 0 ? 1 : 0);
            for (const ExportOption* other : exportOptions())
                QCOMPARE(other->get(changed) != other->get(PackOptions()), other == one);
        }
    }
};

RUBBLE_TEST(ExportOptionTest)
#include "ExportOptionTest.moc"
