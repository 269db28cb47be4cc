// SPDX-License-Identifier: MIT
#if defined(__GNUC__)
#include <plumb/broad/detail/block_search_wide.h>

template struct plumb::WideBlockSearch<16>;
#endif
