//! Which drive this is.

/// Who made the drive, what it is called, and what it says about itself in 1018h.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Identity<'m> {
    id: &'m str,
    vendor: &'m str,
    product: &'m str,
    vendor_id: Option<u32>,
    product_code: Option<u32>,
    revision: Option<u32>,
}

impl<'m> Identity<'m> {
    /// A drive with the id of its profile, its maker's name and its own.
    pub const fn new(id: &'m str, vendor: &'m str, product: &'m str) -> Self {
        Self { id, vendor, product, vendor_id: None, product_code: None, revision: None }
    }

    /// With the vendor id, 1018:01.
    #[must_use]
    pub const fn with_vendor_id(mut self, vendor_id: u32) -> Self {
        self.vendor_id = Some(vendor_id);
        self
    }

    /// With the product code, 1018:02.
    #[must_use]
    pub const fn with_product_code(mut self, product_code: u32) -> Self {
        self.product_code = Some(product_code);
        self
    }

    /// With the revision number, 1018:03.
    #[must_use]
    pub const fn with_revision(mut self, revision: u32) -> Self {
        self.revision = Some(revision);
        self
    }

    /// The id of the profile.
    pub const fn id(&self) -> &'m str {
        self.id
    }

    /// The maker's name.
    pub const fn vendor(&self) -> &'m str {
        self.vendor
    }

    /// The drive's name.
    pub const fn product(&self) -> &'m str {
        self.product
    }

    /// The vendor id, 1018:01; `None` where the manual does not state it.
    pub const fn vendor_id(&self) -> Option<u32> {
        self.vendor_id
    }

    /// The product code, 1018:02; `None` where the manual does not state it.
    pub const fn product_code(&self) -> Option<u32> {
        self.product_code
    }

    /// The revision number, 1018:03; `None` where the manual does not state it.
    pub const fn revision(&self) -> Option<u32> {
        self.revision
    }
}
