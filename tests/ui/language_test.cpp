// SPDX-License-Identifier: GPL-3.0-or-later
// Selecting the language of the panel.
#include "inlanguage.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Language : public WindowTest {
protected:
    /// Selects with the mouse, in the menu.
    void choose(const QString& action) {
        auto* menu = find<QMenu>(u"languageMenu"_s);
        menu->popup(window->mapToGlobal(QPoint(20, 40)));
        QTest::mouseClick(menu, Qt::LeftButton, {},
                          menu->actionGeometry(window->findChild<QAction*>(action)).center());
    }
    [[nodiscard]] QString kept() const { return settings.value(languages::kSetting).toString(); }
    [[nodiscard]] bool told() const {
        return window->findChild<QMessageBox*>(u"languageDialog"_s) != nullptr;
    }
};

TEST_F(Language, EachHasAnEntryUnderItsOwnName) {
    QStringList names;
    for (const QAction* action : find<QMenu>(u"languageMenu"_s)->actions())
        names << action->text();
    EXPECT_EQ(names.takeFirst(), u"&System"_s);
    EXPECT_EQ(names.size(), languages::available().size());
    EXPECT_EQ(names.front(), u"English"_s);
    EXPECT_TRUE(names.contains(u"Deutsch"_s));
    EXPECT_TRUE(window->findChild<QAction*>(u"languageAction_system"_s)->isChecked());
}

TEST_F(Language, TheChoiceIsKeptAndTheWindowSaysWhenItIsTaken) {
    choose(u"languageAction_de"_s);
    EXPECT_EQ(kept(), u"de"_s);
    ASSERT_TRUE(told());
    EXPECT_EQ(window->findChild<QMessageBox*>(u"languageDialog"_s)->text(),
              u"The new language takes effect the next time you start NMC Panel."_s);
    choose(u"languageAction_system"_s);
    EXPECT_EQ(kept(), u""_s);
}

TEST_F(Language, ThatIsChosenAlreadyChangesNothing) {
    choose(u"languageAction_system"_s);
    EXPECT_FALSE(told());
    EXPECT_FALSE(settings.contains(languages::kSetting));
}

TEST(Languages, AreCalledByTheirOwnNames) {
    for (const auto& [language, name] : {std::pair{u"en"_s, u"English"_s}, std::pair{u"de"_s, u"Deutsch"_s},
                                         std::pair{u"fr"_s, u"Français"_s}, std::pair{u"es"_s, u"Español"_s},
                                         std::pair{u"ja"_s, u"日本語"_s}})
        EXPECT_EQ(languages::nameOf(language), name);
}

/// CLDR: a comma in German, Spanish and French, a point in English and Japanese.
TEST(Languages, HaveTheirNumbers) {
    const QLocale american(QLocale::English, QLocale::UnitedStates);
    for (const auto& [language, text] :
         {std::pair{u"de"_s, u"1,5"_s}, std::pair{u"fr"_s, u"1,5"_s}, std::pair{u"es"_s, u"1,5"_s},
          std::pair{u"ja"_s, u"1.5"_s}, std::pair{QString(), u"1.5"_s}})
        EXPECT_EQ(languages::localeOf(language, american).toString(1.5), text) << language.toStdString();
}

TEST(Languages, AreThoseOfTheSystemsCountryWhereItSpeaksThem) {
    const QLocale austrian(QLocale::German, QLocale::Austria);
    EXPECT_EQ(languages::localeOf(u"de"_s, austrian), austrian);
    EXPECT_EQ(languages::localeOf({}, austrian), austrian);
    const QLocale english = languages::localeOf(u"en"_s, austrian);
    EXPECT_EQ(english.language(), QLocale::English);
    EXPECT_EQ(english.measurementSystem(), QLocale::MetricSystem);
    EXPECT_EQ(english.toString(1.5), u"1.5"_s);
}

/// scripts/packages.develop names the packages of missing fonts.
TEST(Languages, HaveFonts) {
    const QFontMetrics font(QApplication::font());
    const QStringList all = languages::available() + QStringList{u"ja"_s};
    for (const QString& language : all)
        for (const char32_t letter : languages::nameOf(language).toStdU32String())
            EXPECT_TRUE(font.inFontUcs4(letter)) << language.toStdString();
}

}  // namespace
}  // namespace nmc
