// Mean and variance of two exponentials of depth, blurred before they are read (Lauritzen & McCool 2008).

import package::moments::evsm4::umbrage_moments_visibility;
import package::sampling::blurred::umbrage_filter;
