#include "editor/document/Translations.h"

#include <QCoreApplication>
#include <QTranslator>

/// Resources of a static library have to be initialised. Q_INIT_RESOURCE does not work inside a namespace.
static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace rubble {

namespace {

constexpr const char* kTranslatorName = "translations";

}  // namespace

void installTranslations() {
    initTranslations();
    QCoreApplication* application = QCoreApplication::instance();
    if (application->findChild<QTranslator*>(kTranslatorName)) return;
    auto* translator = new QTranslator(application);
    translator->setObjectName(kTranslatorName);
    if (translator->load(":/translations/rubble_en.qm")) QCoreApplication::installTranslator(translator);
}

}  // namespace rubble
