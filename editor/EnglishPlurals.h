#pragma once

#include <QTranslator>

namespace rubble {

/// Texts are written in English, with "(s)" where a number decides: "%n seed(s)". This gives "1 seed" and "2 seeds", so that
/// English needs no file of translations.
class EnglishPlurals : public QTranslator {
    Q_OBJECT
public:
    using QTranslator::QTranslator;

    bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* text, const char* disambiguation, int number) const override;
};

}  // namespace rubble
