#pragma once

#include <QStringList>

class QWidget;

namespace rubble::test {

/// The visible texts of a widget and its children that do not fit into their rectangles, or lie outside of their
/// parent: labels, buttons, fields, combo boxes, tabs, headers; each as "QLabel 'Mass': 40 of 52".
QStringList clippedTexts(const QWidget& root);

/// The visible enabled texts whose contrast with their background is below 4.5 : 1 (WCAG 2.1, level AA).
QStringList faintTexts(const QWidget& root);

}  // namespace rubble::test
