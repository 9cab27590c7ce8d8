// Four comparisons around the receiver, weighted bilinearly, each texel compared with a depth of its own: that of a plane at the texel's centre.

import package::sampling::each::umbrage_filter;
import package::sampling::kernel_box::umbrage_kernel;
