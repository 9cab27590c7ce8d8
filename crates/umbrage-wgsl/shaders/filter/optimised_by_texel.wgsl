// A bell of bilinear lookups, each texel compared with a depth of its own: that of a plane at the texel's centre.

import package::sampling::each::umbrage_filter;
import package::sampling::kernel_bell::umbrage_kernel;
