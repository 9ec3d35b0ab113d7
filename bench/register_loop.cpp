// SPDX-License-Identifier: Apache-2.0
// register_loop THREADS: seconds that the threads need for a fixed amount of arithmetic in registers, shared
// evenly. It uses no memory and never waits, so it shows the possible gain by threads on this machine.
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

namespace {

constexpr std::uint64_t k_steps = 600'000'000;

// Marsaglia's xorshift: each step depends on the previous one.
std::uint64_t loop(std::uint64_t steps) {
    std::uint64_t x = 88172645463325252u;
    for (; steps > 0; --steps) {
        x ^= x << 13;
        x ^= x >> 7;
        x ^= x << 17;
    }
    return x;
}

}  // namespace

int main(int count, char** arguments) {
    const int threads = count == 2 ? std::atoi(arguments[1]) : 0;
    if (threads < 1 || threads > 1024) {
        std::fputs("usage: register_loop THREADS\n", stderr);
        return 2;
    }
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::uint64_t> answers(static_cast<std::size_t>(threads));
    std::vector<std::thread> others;
    for (std::uint64_t& answer : answers)
        others.emplace_back(
            [&answer, threads] { answer = loop(k_steps / static_cast<std::uint64_t>(threads)); });
    for (std::thread& thread : others) thread.join();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (answers.front() == 0) return 1;  // never true: it uses the answer
    std::printf("%.9f\n", seconds);
    return 0;
}
