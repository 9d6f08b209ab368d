#include "editor/widgets/appearance/LayerText.h"

#include "core/base/Assert.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "editor/widgets/numbers/NumberText.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <numbers>

namespace rubble {

namespace {

struct LayerTexts {
    Q_DECLARE_TR_FUNCTIONS(LayerText)
};

/// Fills the template of one layer's summary.
class SummaryWriter {
public:
    SummaryWriter(const LayerParameters& parameters, const Units& units, const QLocale& locale)
        : m_parameters(parameters), m_kind(kindOf(parameters)), m_units(units), m_locale(locale) {}

    QString text() const {
        static const QRegularExpression kPlaceholder(R"(\{(\w+)(?:\|([^|}]*)\|([^}]*))?\})");
        const QString summary = patternText(m_kind.summary(m_parameters));
        QString result;
        qsizetype from = 0;
        for (auto found = kPlaceholder.globalMatch(summary); found.hasNext();) {
            const QRegularExpressionMatch match = found.next();
            result += summary.mid(from, match.capturedStart() - from);
            result += valueText(match.captured(1).toStdString(), match.captured(2), match.captured(3));
            from = match.capturedEnd();
        }
        return result + summary.mid(from);
    }

private:
    QString valueText(const std::string& name, const QString& singular, const QString& plural) const {
        if (name == "elements") {
            return number(static_cast<double>(m_kind.elementCount(m_parameters)), singular, plural);
        }
        const auto parameter = std::ranges::find(m_kind.parameters, name, &LayerParameter::name);
        RUBBLE_ASSERT(parameter != m_kind.parameters.end());
        const ParameterValue value = parameter->read(m_parameters);
        if (const auto* count = std::get_if<SeedCount>(&value)) return countText(*count, singular, plural);
        const double real = std::get<double>(value);
        switch (parameter->quantity) {
            case Quantity::Length: return localizedQuantity(QuantityKind::Length, real, m_units, m_locale);
            case Quantity::Angle: return roundedText(real * 180.0 / std::numbers::pi, {}, m_locale) + QChar(u'°');
            case Quantity::Number: break;
        }
        return number(real, singular, plural);
    }
    QString countText(const SeedCount& count, const QString& singular, const QString& plural) const {
        switch (count.by) {
            case CountBy::Number: break;
            case CountBy::Density: return LayerTexts::tr("%1 per m²").arg(roundedText(count.amount, {}, m_locale));
            case CountBy::FragmentSize:
                return LayerTexts::tr("fragments of %1")
                    .arg(localizedQuantity(QuantityKind::Length, count.amount, m_units, m_locale));
        }
        return number(count.amount, singular, plural);
    }
    QString number(double value, const QString& singular, const QString& plural) const {
        const QString text = roundedText(value, {}, m_locale);
        if (plural.isEmpty()) return text;
        return value == 1.0 ? singular : plural.arg(text);
    }

    const LayerParameters& m_parameters;
    const PatternKind& m_kind;
    const Units& m_units;
    const QLocale& m_locale;
};

}  // namespace

QString patternText(const char* text) { return QCoreApplication::translate("Pattern", text); }

QString layerKindName(const LayerParameters& parameters) { return patternText(kindOf(parameters).caption); }

QString inTitleCase(QString text) {
    for (qsizetype k = 1; k < text.size(); ++k) {
        if (text[k - 1] == ' ') text[k] = text[k].toUpper();
    }
    return text;
}

QString layerText(const PatternLayer& layer, const Units& units, const QLocale& locale) {
    return LayerTexts::tr("%1, %2").arg(layerKindName(layer.parameters),
                                        SummaryWriter(layer.parameters, units, locale).text());
}

QString numberedLayerText(const PatternLayer& layer, const Units& units, const QLocale& locale) {
    return LayerTexts::tr("%1 · %2").arg(QString::number(layer.id), layerText(layer, units, locale));
}

}  // namespace rubble
