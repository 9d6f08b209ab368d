#pragma once

#include <QString>

#include <string>

namespace rubble {

/// A name from a file for a sentence or a title: see shownName() in core/base/MessageText.h.
QString nameText(const std::string& name);

/// The same for the name of the file at a path.
QString fileNameText(const QString& path);

/// A path for a sentence: printable, whole.
QString pathText(const QString& path);

/// A name as the text of a menu item or a button, where "&" marks a shortcut.
QString menuText(const QString& name);

/// A sentence as a tooltip. Qt takes one that looks like HTML for HTML, and reads the files that it names.
QString toolTipText(const QString& sentence);

}  // namespace rubble
