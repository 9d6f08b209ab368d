#include "editor/panels/docks/ExpectationText.h"

#include "editor/commands/Renaming.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QCoreApplication>

#include <array>

namespace rubble {

namespace {

struct ExpectationTexts {
    Q_DECLARE_TR_FUNCTIONS(rubble::ExpectationTexts)
};

/// What the value of an expectation is.
enum class ValueKind { None, Count, Time, Length, Speed, Fraction };

/// The texts of a kind of expectation.
struct Kind {
    const char* name;
    const char* ofInstance;  // %1: the instance's name, %2: the value
    const char* ofAll;       // %1: the value
    ValueKind value;
};
constexpr std::array<Kind, kExpectationKinds> kKinds{
    {{QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Stays intact"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "%1 stays intact for %2"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Everything stays intact for %1"), ValueKind::Time},
     {QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Breaks"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "%1 breaks"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Something breaks"), ValueKind::None},
     {QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Does not break"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "%1 does not break"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Nothing breaks"), ValueKind::None},
     {QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Breaks into at least"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "%1 breaks into at least %2 fragments"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Something breaks into at least %1 fragments"), ValueKind::Count},
     {QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Ends below height"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "%1 ends below a height of %2"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Everything ends below a height of %1"), ValueKind::Length},
     {QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Ends below speed"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "%1 ends below a speed of %2"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Everything ends below a speed of %1"), ValueKind::Speed},
     {QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Stays up"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "%1 loses at most %2 of its mass"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Every instance loses at most %1 of its mass"),
      ValueKind::Fraction},
     {QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Holes at most"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "%1 has holes of at most %2"),
      QT_TRANSLATE_NOOP("rubble::ExpectationTexts", "Every instance has holes of at most %1"), ValueKind::Length}}};

const Kind& kindOf(ExpectationKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

}  // namespace

QStringList expectationKindNames() {
    QStringList names;
    for (const Kind& kind : kKinds) names << ExpectationTexts::tr(kind.name);
    return names;
}

std::optional<NumberFormat> expectationFormat(ExpectationKind kind, const Units& units) {
    switch (kindOf(kind).value) {
        case ValueKind::None: return std::nullopt;
        case ValueKind::Count: return NumberFormat{};
        case ValueKind::Time: return Units::seconds();
        case ValueKind::Length: return units.lengths();
        case ValueKind::Speed: return Units::speeds();
        case ValueKind::Fraction: return Units::percents();
    }
    return std::nullopt;
}

QString expectationText(const Expectation& expectation, const Project& project, const Units& units) {
    const Kind& kind = kindOf(expectation.kind);
    const std::optional<NumberFormat> format = expectationFormat(expectation.kind, units);
    const QString value = format ? roundedQuantity(expectation.value, *format) : QString();
    if (expectation.instance == 0) {
        const QString text = ExpectationTexts::tr(kind.ofAll);
        return format ? text.arg(value) : text;
    }
    const QString text = ExpectationTexts::tr(kind.ofInstance);
    const QString name = nameText(nameOf(project, Part::Instance, expectation.instance).toStdString());
    return format ? text.arg(name, value) : text.arg(name);
}

double defaultExpectationValue(ExpectationKind kind) {
    switch (kind) {
        case ExpectationKind::StandsUntouched: return 5.0;    // s
        case ExpectationKind::BreaksIntoAtLeast: return 2.0;  // fragments
        case ExpectationKind::NothingAbove: return 1.0;       // m
        case ExpectationKind::NothingFaster: return 0.5;      // m/s
        case ExpectationKind::StaysUp: return 0.1;            // of the mass
        case ExpectationKind::HoleAtMost: return 0.5;         // m
        case ExpectationKind::Breaks:
        case ExpectationKind::DoesNotBreak: break;
    }
    return 0.0;
}

}  // namespace rubble
