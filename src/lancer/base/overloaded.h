// A visitor of a variant from one function for each kind. Without one that takes anything, a new kind does not compile until it has its own.
#pragma once

namespace lancer {

template <class... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace lancer
