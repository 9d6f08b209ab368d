#pragma once

#include <QString>

#include <functional>

class QHBoxLayout;
class QLineEdit;

namespace rubble {

/// Returns "<folder>/<name><suffix>", with a number if that exists with or without the suffix.
QString unusedPath(const QString& folder, const QString& name, const QString& suffix);

/// Returns a row with the field of a path and a Browse button.
QHBoxLayout* createPathRow(QLineEdit& path, std::function<void()> browse);

}  // namespace rubble
