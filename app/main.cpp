// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QLoggingCategory>
#include <QProxyStyle>
#include <QStandardPaths>
#include <QTextStream>

#include "app/commandline.h"
#include "app/composition.h"
#include "app/panelsettings.h"
#include "app/translations.h"
#include "app/unixsignals.h"
#include "link/connection/crashburst.h"
#include "link/ports/portlist.h"
#include "widgets/common/languages.h"
#include "widgets/common/look.h"
#include "widgets/common/texts.h"
#include "widgets/help/manual.h"

namespace {

Q_LOGGING_CATEGORY(startLog, "nmc.start", QtWarningMsg)

constexpr int kNoDisplay = 3;

int say(const nmc::Say& words) {
    if (!words.text.isEmpty())
        QTextStream(words.exitCode == 0 ? stdout : stderr) << words.text << Qt::endl;
    return words.exitCode;
}

/// QApplication aborts without a display; a message is better.
bool displayMissing() {
    return qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
           qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
}

/// Logs the style, icon, colours, languages and manual found on this computer.
void logStart(const nmc::Translations& translations) {
    if (!startLog().isInfoEnabled())
        return;
    const QString platform = QGuiApplication::platformName();
    const auto* own = qobject_cast<const QProxyStyle*>(QApplication::style());
    const QString style = own != nullptr ? own->baseStyle()->name() : QApplication::style()->name();
    const QSize icon = QApplication::windowIcon().pixmap(64, 64).size();
    const bool dark = nmc::look::isDark(QApplication::palette());
    qCInfo(startLog).noquote().nospace()
        << "version " NMC_VERSION ", Qt " << qVersion() << " on " << platform << ", style " << style << ", "
        << (dark ? "dark" : "light") << ", icon " << icon.width() << "x" << icon.height() << ", language "
        << translations.panel.language() << ", Qt's " << translations.qt.language() << ", manual of "
        << nmc::Manual().pages().size() << " pages";
}

}  // namespace

int main(int argc, char** argv) {
    nmc::nameApplication();
    nmc::PanelSettings settings;
    const QLocale locale = nmc::languages::localeOf(settings.value(nmc::languages::kSetting).toString());
    QLocale::setDefault(locale);
    nmc::Translations translations;
    nmc::Start start;
    {
        const QCoreApplication withoutDisplay(argc, argv);
        nmc::installTranslations(translations, locale);
        const auto asked = nmc::readCommandLine(QCoreApplication::arguments(), nmc::serialPorts);
        if (const auto* words = std::get_if<nmc::Say>(&asked))
            return say(*words);
        if (displayMissing())
            return say({nmc::texts::noDisplay(), kNoDisplay});
        start = std::get<nmc::Start>(asked);
    }

    const nmc::crashburst::HandlerStack stack;
    nmc::crashburst::installHandlers();
    QApplication application(argc, argv);
    nmc::look::setUp(application);
    // Again, because translators belong to the application object.
    nmc::installTranslations(translations, locale);
    logStart(translations);
    nmc::Composition composition(settings, {},
                                 QStandardPaths::writableLocation(QStandardPaths::AppDataLocation));
    const nmc::UnixSignals signalsOfTheSystem(&composition.worker());
    QObject::connect(&signalsOfTheSystem, &nmc::UnixSignals::terminationAsked, &composition,
                     &nmc::Composition::stopAndQuit);
    composition.show(start);
    const int exitCode = QApplication::exec();
    qCDebug(startLog) << "painted, or ended";  // for scripts/bench start, which quits after the first paint
    return exitCode;
}
