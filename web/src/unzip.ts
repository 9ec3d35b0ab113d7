// SPDX-License-Identifier: Apache-2.0
// What is needed of the library that opens .zip files, to be loaded later than the page.
export {unzipSync} from 'fflate';
