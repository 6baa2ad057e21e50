// SPDX-License-Identifier: GPL-3.0-or-later
// Compares what the manual says about the window with the window itself.
#include "windowtest.h"

namespace nmc {
namespace {

QString page(const QString& name) {
    QFile file(QStringLiteral(MANUAL_DIR "/") + name);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return QString::fromUtf8(file.readAll());
}

/// The keys in the first column of its tables.
QSet<QString> keysOfThePage() {
    static const QRegularExpression row(u"^\\| ([^|]*`[^|]*) \\|"_s, QRegularExpression::MultilineOption);
    static const QRegularExpression key(u"`([^`]+)`"_s);
    QSet<QString> keys;
    const QString text = page(u"keys.md"_s);
    for (const auto& cell : row.globalMatch(text))
        for (const auto& one : key.globalMatch(cell.captured(1)))
            keys << one.captured(1);
    return keys;
}

class Manual : public WindowTest {
protected:
    /// Collects the keys of everything that is in the window now, apart from underlined letters.
    void collectKeys() {
        const auto take = [this](const QKeySequence& key, const QObject* owner) {
            if (!key.isEmpty() && !key.toString().startsWith(u"Alt+"_s))
                keys.insert(key.toString(), owner->objectName());
        };
        for (const QAction* action : window->findChildren<QAction*>())
            for (const QKeySequence& key : action->shortcuts())
                take(key, action);
        for (const QShortcut* shortcut : window->findChildren<QShortcut*>())
            take(shortcut->key(), shortcut->parent());
        for (const QAbstractButton* button : window->findChildren<QAbstractButton*>())
            take(button->shortcut(), button);
    }
    QHash<QString, QString> keys;  ///< with the name of the owner
};

TEST_F(Manual, NamesEveryKey) {
    for (const ModuleType type : {ModuleType::Servo, ModuleType::Stepper}) {
        showInEveryDock({type, 1});
        collectKeys();
    }
    window->findChild<QAction*>(u"manualAction"_s)->trigger();
    collectKeys();
    // They belong to the window, to a dock that is created when it is shown, and to a page of each module.
    for (const QString& key : {u"F5"_s, u"Ctrl+Alt+Z"_s, u"Ctrl+0"_s, u"Ctrl+L"_s, u"F1"_s, u"Ctrl+F"_s})
        ASSERT_TRUE(keys.contains(key)) << key.toStdString();
    const QSet<QString> told = keysOfThePage();
    for (auto key = keys.cbegin(); key != keys.cend(); ++key)
        EXPECT_TRUE(told.contains(key.key()))
            << key.key().toStdString() << " of " << key.value().toStdString() << " is not in keys.md";
}

TEST_F(Manual, SaysWhichDockHasWhichNumber) {
    for (const auto& [key, dock] :
         {std::pair{u"Ctrl+4"_s, u"Modules"_s}, std::pair{u"Ctrl+5"_s, u"Scope"_s},
          std::pair{u"Ctrl+6"_s, u"Messages"_s}, std::pair{u"Ctrl+7"_s, u"Simulator"_s},
          std::pair{u"Ctrl+8"_s, u"Packet monitor"_s}}) {
        const auto docks = window->findChildren<QDockWidget*>();
        const auto found = std::find_if(docks.begin(), docks.end(), [&key = key](QDockWidget* each) {
            return each->toggleViewAction()->shortcut().toString() == key;
        });
        ASSERT_NE(found, docks.end()) << key.toStdString();
        EXPECT_EQ((*found)->windowTitle(), dock);
    }
    EXPECT_TRUE(
        page(u"keys.md"_s).contains(u"| docks Modules, Scope, Messages, Simulator, Packet monitor |"_s));
}

}  // namespace
}  // namespace nmc
