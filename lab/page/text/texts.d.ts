// SPDX-License-Identifier: Apache-2.0
// Files that the page has as text.
declare module "*.yaml" {
  const text: string;
  export default text;
}
