// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QLocalSocket>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "tests/support/runtimefolder.h"
#include "tests/support/virtualpanel.h"

namespace nmc::testing_support {

/// Another program, as simple as one can be.
class OtherProgram {
public:
    using Json = nlohmann::json;

    OtherProgram(VirtualPanel& panel, const QString& path) : m_panel(panel) {
        m_socket.connectToServer(path);
    }

    void write(const QByteArray& line) {
        m_socket.write(line + '\n');
        m_socket.flush();
    }
    int request(const char* method, const Json& parameters = Json::object()) {
        write(QByteArray::fromStdString(
            Json{{"jsonrpc", "2.0"}, {"id", ++m_id}, {"method", method}, {"params", parameters}}.dump()));
        return m_id;
    }
    /// The answer to a request, once it is there.
    Json answer(int id) {
        const auto isIt = [&](const Json& line) { return line.contains("id") && line["id"] == id; };
        return await(isIt);
    }
    Json notification(const char* method) {
        return await([&](const Json& line) { return line.value("method", "") == method; });
    }
    Json call(const char* method, const Json& parameters = Json::object()) {
        return answer(request(method, parameters));
    }
    void hello(const char* name = "scan.py") {
        ASSERT_TRUE(call("hello", {{"protocol", "1.0"}, {"program", name}}).contains("result"));
    }
    [[nodiscard]] bool cutOff() {
        return m_panel.waitFor([&] { return m_socket.state() == QLocalSocket::UnconnectedState; });
    }
    void vanish() { m_socket.abort(); }
    /// Whether it reads what arrives. What it does not read waits in the system, and then in the panel.
    void setReading(bool reads) { m_socket.setReadBufferSize(reads ? 0 : 1); }
    /// Lines that have arrived and were not asked for yet.
    std::vector<Json>& arrived() {
        while (m_socket.canReadLine())
            m_lines.push_back(Json::parse(m_socket.readLine().toStdString()));
        return m_lines;
    }

private:
    template <typename Condition>
    Json await(const Condition& isIt) {
        Json found;
        EXPECT_TRUE(m_panel.waitFor([&] {
            const auto line = std::find_if(arrived().begin(), arrived().end(), isIt);
            if (line == m_lines.end())
                return false;
            found = *line;
            m_lines.erase(line);
            return true;
        }));
        return found;
    }

    VirtualPanel& m_panel;
    QLocalSocket m_socket;
    std::vector<Json> m_lines;
    int m_id = 1'000;  ///< other than in what a test writes itself
};

}  // namespace nmc::testing_support
