#include "editor/document/ShownText.h"

#include "core/base/MessageText.h"
#include "editor/document/FilePath.h"

#include <QTextDocument>

namespace rubble {

QString nameText(const std::string& name) { return QString::fromStdString(shownName(name)); }

QString fileNameText(const QString& path) { return nameText(toPath(path).filename().native()); }

QString pathText(const QString& path) { return QString::fromStdString(printableText(toPath(path).native())); }

QString menuText(const QString& name) { return QString(name).replace('&', "&&"); }

QString toolTipText(const QString& sentence) {
    return Qt::mightBeRichText(sentence) ? Qt::convertFromPlainText(sentence, Qt::WhiteSpaceNormal) : sentence;
}

}  // namespace rubble
