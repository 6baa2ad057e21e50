// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include "app/translations.h"
#include "widgets/common/texts.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;

QStringList placeholders(const QString& text) {
    static const QRegularExpression placeholder(u"%\\d"_s);
    QStringList found;
    for (auto match = placeholder.globalMatch(text); match.hasNext();)
        found << match.next().captured();
    found.sort();
    return found;
}

TEST(Translation, TheTableOfTextsIsGermanForAGermanLocale) {
    {
        Translations translations;
        ASSERT_TRUE(installTranslations(translations, QLocale(QLocale::German, QLocale::Germany)));
        EXPECT_EQ(texts::safety().headline,
                  u"Einen Hardware-Not-Halt vorsehen, der die Motorversorgung trennt."_s);
        EXPECT_EQ(texts::countOfModules(3), u"3 Module"_s);
        EXPECT_EQ(QCoreApplication::translate("nmc::StopButton", "STOP ALL"), u"ALLES STOPP"_s);
    }
    // Translators leave the application when they go.
    EXPECT_EQ(texts::countOfModules(3), u"3 modules"_s);
}

TEST(Translation, EnglishAndUnknownLanguagesStayEnglish) {
    Translations translations;
    EXPECT_FALSE(installTranslations(translations, QLocale::c()));
    EXPECT_FALSE(installTranslations(translations, QLocale(QLocale::English, QLocale::Canada)));
    EXPECT_FALSE(installTranslations(translations, QLocale(QLocale::Finnish, QLocale::Finland)));
    EXPECT_EQ(texts::countOfModules(3), u"3 modules"_s);
}

TEST(Translation, EveryGermanMessageIsFinished) {
    QFile file(QStringLiteral(TS_PATH));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString source;
    int messages = 0;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == u"source"_s) {
            source = xml.readElementText();
        } else if (xml.name() == u"translation"_s) {
            const QString type = xml.attributes().value(u"type"_s).toString();
            const QString translation = xml.readElementText();
            EXPECT_TRUE(type.isEmpty()) << type.toStdString() << ": " << source.toStdString();
            EXPECT_FALSE(translation.isEmpty()) << source.toStdString();
            EXPECT_EQ(placeholders(translation), placeholders(source)) << source.toStdString();
            EXPECT_EQ(translation.contains(u'&'), source.contains(u'&')) << source.toStdString();
            ++messages;
        }
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    EXPECT_GT(messages, 0);
}

}  // namespace
}  // namespace nmc
